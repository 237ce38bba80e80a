// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/motors/gamepad.h"

#include "protocol/codec/quantities.h"

#ifdef TREX_HAS_SDL2
#define SDL_MAIN_HANDLED
#include <SDL.h>
#endif

#include <cmath>

namespace trex {

namespace {

constexpr double kReach = 32767.0;
constexpr double kSlack = 0.15; ///< of the reach; worn sticks rest further out than new ones

int onAxis(int raw)
{
    const double share = std::clamp(raw / kReach, -1.0, 1.0);
    const double beyond = std::max(std::abs(share) - kSlack, 0.0) / (1.0 - kSlack);
    return static_cast<int>(std::lround(std::copysign(beyond, share) * kFullSpeed));
}

} // namespace

std::pair<int, int> stickOrder(int x, int y, bool isDeadManHeld)
{
    return isDeadManHeld ? std::pair{-onAxis(y), onAxis(x)} : std::pair{0, 0};
}

#ifdef TREX_HAS_SDL2

/// The first gamepad that SDL knows how to read; others have no shoulder button to trust.
class Gamepad::Device {
public:
    Device()
    {
        SDL_SetMainReady();
        SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1"); // those are ours
        // There is no window of SDL's that could have the focus; whether ours has it, the panel
        // sees.
        SDL_SetHint(SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS, "1");
        m_isOk = SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER) == 0;
    }
    ~Device()
    {
        close();
        if (m_isOk) {
            SDL_QuitSubSystem(SDL_INIT_GAMECONTROLLER);
        }
    }
    Q_DISABLE_COPY_MOVE(Device)

    /// False: there is none.
    bool update()
    {
        if (!m_isOk) {
            return false;
        }
        SDL_GameControllerUpdate();
        if (m_controller != nullptr && SDL_GameControllerGetAttached(m_controller) == SDL_FALSE) {
            close();
        }
        for (int i = 0; m_controller == nullptr && i < SDL_NumJoysticks(); ++i) {
            if (SDL_IsGameController(i) == SDL_TRUE) {
                m_controller = SDL_GameControllerOpen(i);
            }
        }
        return m_controller != nullptr;
    }
    [[nodiscard]] QString name() const
    {
        return QString::fromUtf8(SDL_GameControllerName(m_controller));
    }
    [[nodiscard]] std::pair<int, int> order() const
    {
        const auto isDown = [this](SDL_GameControllerButton button) {
            return SDL_GameControllerGetButton(m_controller, button) != 0;
        };
        return stickOrder(SDL_GameControllerGetAxis(m_controller, SDL_CONTROLLER_AXIS_LEFTX),
                          SDL_GameControllerGetAxis(m_controller, SDL_CONTROLLER_AXIS_LEFTY),
                          isDown(SDL_CONTROLLER_BUTTON_LEFTSHOULDER)
                              || isDown(SDL_CONTROLLER_BUTTON_RIGHTSHOULDER));
    }

private:
    void close()
    {
        if (m_controller != nullptr) {
            SDL_GameControllerClose(std::exchange(m_controller, nullptr));
        }
    }
    bool m_isOk = false;
    SDL_GameController* m_controller = nullptr;
};

bool Gamepad::isBuiltIn()
{
    return true;
}

#else

class Gamepad::Device {
public:
    bool update() { return false; }
    [[nodiscard]] QString name() const { return {}; }
    [[nodiscard]] std::pair<int, int> order() const { return {}; }
};

bool Gamepad::isBuiltIn()
{
    return false;
}

#endif

Gamepad::Gamepad(QObject* parent) : QObject(parent), m_timer(this)
{
    m_timer.setInterval(kInterval);
    m_timer.setTimerType(Qt::PreciseTimer);
    connect(&m_timer, &QTimer::timeout, this, &Gamepad::look);
}

Gamepad::~Gamepad() = default;

void Gamepad::listen(bool wanted)
{
    if (!wanted) {
        m_timer.stop();
        set({});
    } else if (isBuiltIn() && !m_timer.isActive()) {
        if (!m_device) {
            m_device = std::make_unique<Device>();
        }
        m_timer.start();
    }
}

void Gamepad::look()
{
    if (m_device->update()) {
        setName(m_device->name());
        set(m_device->order());
    } else {
        setName({});
        set({});
    }
}

void Gamepad::set(std::pair<int, int> order)
{
    // Again and again while it drives: whether it may is for the listener to see, each time.
    const bool isNews = order != std::exchange(m_order, order);
    if (isNews || order != std::pair{0, 0}) {
        emit moved(order.first, order.second);
    }
}

void Gamepad::setName(const QString& name)
{
    if (name != std::exchange(m_name, name)) {
        emit nameChanged();
    }
}

} // namespace trex
